/*
 * sheen_version.h - which sheen this is, for #if and for messages. CMakeLists.txt reads it here.
 */
#ifndef SHEEN_VERSION_H
#define SHEEN_VERSION_H

#define SHEEN_VERSION_MAJOR 0 /* of the interface, once it is 1 */
#define SHEEN_VERSION_MINOR 2 /* until then of the interface */
#define SHEEN_VERSION_PATCH 0 /* repairs */
#define SHEEN_VERSION "0.2.0" /* all three */

#endif
