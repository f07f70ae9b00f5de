// For: transparency.h
// Codes of units: what tr_unit_code makes. Bits 0 to 15: id, 16 to 20: TR_UNIT_*, 24 to 31: importance in 255ths.
#define TR_CODE_TARGET (1u << 16)
#define TR_CODE_CLOSES (10u << 16) // impenetrable or backdrop
#define TR_CODE_HOLLOW (4u << 16)
