/*
 * pose.h - private: checks of poses, and products that are not repaired. The rest of pose.c is public.
 */
#ifndef SHEEN_POSE_H
#define SHEEN_POSE_H

#include "../sheen.h"

/* 1 if the rows' squared lengths and dot products are off by at most `within`, Q1.30; a mirroring matrix passes. */
int sheen_is_rotation(const sheen_q30_t r[9], int32_t within);

/* 1 if no rotation is given; 1 if nothing of the pose is given at all. */
int sheen_rotation_is_zero(const sheen_q30_t r[9]);
int sheen_pose_is_zero(const struct sheen_pose *pose);

/* 1 if the pose is valid, its zeros counted as defaults. */
int sheen_pose_valid(const struct sheen_pose *pose);

/* Component i of v moved by the pose, Q7.24. */
int64_t sheen_pose_part(const struct sheen_pose *pose, int i, const sheen_q24_t v[3]);

/*
 * out = outer * inner, zeros in both counted as defaults; entries are within 1 raw step of the product, and the
 * rotation is not made orthonormal again.
 */
int sheen_pose_place(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out);

#endif
