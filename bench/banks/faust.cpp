/* Around the bank of MODES that Faust makes of bank.dsp: so many copies ring together.

   faust COPIES RUNS    prints the modes that one core renders in real time at 48 kHz, in blocks of
                        64, by the least of so many short runs */

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "least.h"

/* What the generated class refers to. */
#define FAUSTFLOAT float
struct Meta {
    void declare(const char *, const char *) {}
};
struct UI {
    void openVerticalBox(const char *) {}
    void closeBox() {}
};
struct dsp {
    virtual ~dsp() {}
};

<<includeIntrinsic>>
<<includeclass>>

namespace {

constexpr int BLOCK = 64, BLOCKS = 4;
constexpr double RATE_HZ = 48000;

struct Banks {
    std::vector<mydsp> copies;
    float in[BLOCK], out[2][BLOCK];

    void render()
    {
        float *inputs[] = {in}, *outputs[] = {out[0], out[1]};
        for (mydsp &copy : copies) {
            copy.compute(BLOCK, inputs, outputs);
            heed(this);
        }
    }
};

void run(void *state)
{
    for (int i = 0; i < BLOCKS; i++)
        static_cast<Banks *>(state)->render();
}

} // namespace

int main(int count, char **words)
{
    if (count != 3)
        return 2;
    Banks banks{std::vector<mydsp>(std::atoi(words[1])), {1}, {}};
    for (mydsp &copy : banks.copies)
        copy.init(RATE_HZ);
    banks.render();
    banks.in[0] = 0;
    double spent_s = least_s(run, &banks, std::atoi(words[2]));
    double modes = MODES * static_cast<double>(banks.copies.size());
    std::printf("%.0f\n", modes * (BLOCK * BLOCKS / RATE_HZ) / spent_s);
    return 0;
}
