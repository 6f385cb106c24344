/** Number of random cases per fuzz test: 1,000, or as set by `npm run fuzz`. */
export const fuzzRuns = Number(process.env['FUZZ_RUNS'] ?? 1_000);
