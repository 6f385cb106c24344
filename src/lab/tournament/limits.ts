/**
 * The most programs and matches of a tournament, on the page as in its file. Chosen: a school's year with all its classes, and a
 * file of its results that can still be opened.
 */
export const tournamentLimits = { programs: { min: 1, max: 200 }, matches: 50_000 } as const;
