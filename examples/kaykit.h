/* kaykit.h: trees and houses of Kay Lousberg's "Medieval Hexagon Pack", or of any folder with files of those names, in
 * place of the battlefield's own. */
#ifndef KAYKIT_H
#define KAYKIT_H

#include "battlefield.h"

/* False: a file is missing or damaged, or out of memory; message says which, b may be changed in part. */
bool kaykit_replace(battlefield *b, const char *folder, char *message, size_t message_size);

#endif
