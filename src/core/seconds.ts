/** Seconds as the whole µs that a clock can reach: 4.1 s are not 4,099,999.9999999995 µs. */
export const usOf = (seconds: number): number => Math.round(seconds * 1_000_000);
