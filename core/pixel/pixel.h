/*
 * pixel.h - private: what a pixel is made of, in the order of the data: light gives intensities, these give channels by
 * a material's terms, a tile has the depth test, and channels are rounded once; or a finished pixel comes from a table.
 */
#ifndef SHEEN_PIXEL_H
#define SHEEN_PIXEL_H

#include "intensity.h"
#include "rounding.h"
#include "shades.h"
#include "terms.h"
#include "tile.h"

#endif
