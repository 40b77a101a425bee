/*
 * sdkconfig.h - stands for the header that ESP-IDF makes of a project's configuration, which the compiler gets by -D.
 */
