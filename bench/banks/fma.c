/* Fused multiply-adds that one core issues in a second: what any bank of oscillators has to spend.

   fma RUNS    prints the rate, with vectors of BYTES, by the least of so many short runs */

#include <stdio.h>
#include <stdlib.h>

#include "least.h"

typedef float vector __attribute__((vector_size(BYTES)));

/* More than latency times units on any machine there is, and no more than there are registers. */
enum { CHAINS = 12, ROUNDS = 100000 };

static void run(void *state)
{
    vector *sums = state, factor = sums[CHAINS], term = sums[CHAINS + 1], held[CHAINS];
#pragma GCC unroll 16
    for (int k = 0; k < CHAINS; k++)
        held[k] = sums[k];
    for (int i = 0; i < ROUNDS; i++) {
#pragma GCC unroll 16
        for (int k = 0; k < CHAINS; k++) {
            held[k] = held[k] * factor + term;
            /* Keeps each chain in a register of its own, and the loop from being vectorised. */
            __asm__("" : "+v"(held[k]));
        }
    }
#pragma GCC unroll 16
    for (int k = 0; k < CHAINS; k++)
        sums[k] = held[k];
    heed(state);
}

int main(int count, char **words)
{
    static vector sums[CHAINS + 2];
    if (count != 2)
        return 2;
    sums[CHAINS] += 0.5f;
    sums[CHAINS + 1] += 1.0f;
    printf("%.0f\n", (double)CHAINS * ROUNDS / least_s(run, sums, atoi(words[1])));
    return 0;
}
