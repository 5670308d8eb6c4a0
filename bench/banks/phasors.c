/* The obvious bank: phasors z <- z w in arrays of floats, all modes for each sample, two gains.

   phasors MODES RUNS    prints the modes that one core renders in real time at 48 kHz, in blocks
                         of 64, by the least of so many short runs */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "least.h"

enum { BLOCK = 64, BLOCKS = 16 };
static const double PI = 3.14159265358979323846, RATE_HZ = 48000.0, T60_S = 60.0;

struct bank {
    int modes;
    float *x, *y, *re, *im, *left, *right;
    float out[2][BLOCK];
};

static float *column(int modes)
{
    size_t bytes = ((size_t)modes * sizeof(float) + 63) / 64 * 64;
    float *values = aligned_alloc(64, bytes);
    if (!values)
        exit(1);
    return values;
}

static void render(struct bank *bank)
{
    float *restrict x = bank->x, *restrict y = bank->y;
    const float *restrict re = bank->re, *restrict im = bank->im;
    const float *restrict left = bank->left, *restrict right = bank->right;
    for (int n = 0; n < BLOCK; n++) {
        float sum[2] = {0, 0};
        for (int k = 0; k < bank->modes; k++) {
            float turned = x[k] * re[k] - y[k] * im[k];
            float moved = x[k] * im[k] + y[k] * re[k];
            x[k] = turned;
            y[k] = moved;
            sum[0] += left[k] * moved;
            sum[1] += right[k] * moved;
        }
        bank->out[0][n] = sum[0];
        bank->out[1][n] = sum[1];
    }
}

static void run(void *state)
{
    for (int i = 0; i < BLOCKS; i++) {
        render(state);
        heed(state);
    }
}

int main(int count, char **words)
{
    if (count != 3)
        return 2;
    int modes = atoi(words[1]);
    struct bank bank = {.modes = modes,
                        .x = column(modes), .y = column(modes),
                        .re = column(modes), .im = column(modes),
                        .left = column(modes), .right = column(modes)};
    double radius = exp(-log(1000.0) / (T60_S * RATE_HZ));
    for (int k = 0; k < modes; k++) {
        double angle = 2 * PI * (50.0 + 15000.0 * k / modes) / RATE_HZ;
        bank.x[k] = 1;
        bank.y[k] = 0;
        bank.re[k] = (float)(radius * cos(angle));
        bank.im[k] = (float)(radius * sin(angle));
        bank.left[k] = (float)k / (float)modes;
        bank.right[k] = 1 - bank.left[k];
    }
    double spent_s = least_s(run, &bank, atoi(words[2]));
    printf("%.0f\n", modes * (BLOCK * BLOCKS / RATE_HZ) / spent_s);
    return 0;
}
