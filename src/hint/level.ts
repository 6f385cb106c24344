/** How much a hint tells: the moment, the lines, the kind of change, the change itself. */
export const hintLevels = [1, 2, 3, 4] as const;
export type HintLevel = (typeof hintLevels)[number];

/** The most programs that are tried for a hint. Chosen: a school's computer tries them in about 20 s. */
export const USUAL_BUDGET = 400;
export const budgetLimits = { min: 0, max: 100_000 } as const;
