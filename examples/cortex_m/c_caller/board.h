/* The functions of the board that the program needs. */

#ifndef BOARD_H
#define BOARD_H

/* Sends a text to the host, over semihosting. */
void print(const char *text);

#endif
