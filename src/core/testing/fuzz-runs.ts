/** How many random cases a fuzz test tries: 1,000, or what `npm run fuzz` says. */
export const fuzzRuns = Number(process.env['FUZZ_RUNS'] ?? 1_000);
