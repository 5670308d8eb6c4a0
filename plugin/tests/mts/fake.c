/* A stand-in for the library of MTS-ESP: what clients call, and what the tests turn. */

#include <stdbool.h>
#include <stddef.h>

#ifdef _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT
#endif

static double table[128];
static bool master;
static int clients;
static const char *name = "Eikosany";

EXPORT void MTS_RegisterClient(void) { clients++; }
EXPORT void MTS_DeregisterClient(void) { clients--; }
EXPORT bool MTS_HasMaster(void) { return master; }
EXPORT const char *MTS_GetScaleName(void) { return name; }

/* Key 61 is silent, 62 on channel 9 only, 63 where the channel is unknown. */
EXPORT bool MTS_ShouldFilterNote(char key, char channel) {
    return key == 61 || (key == 62 && channel == 9) || (key == 63 && channel == (char)-1);
}

#ifndef NO_TABLE_FUNCTION
EXPORT const double *MTS_GetTuningTable(void) {
#ifdef NO_TABLE
    return NULL;
#else
    return table;
#endif
}
#endif

EXPORT void fake_master(bool is_there) { master = is_there; }
EXPORT void fake_tune(int key, double hz) { table[key] = hz; }
EXPORT void fake_name(const char *text) { name = text; }
EXPORT int fake_clients(void) { return clients; }
