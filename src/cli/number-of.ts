/** The number that a plain decimal text says; NaN for everything else. */
export const numberOf = (text: string): number => (/^\d+(\.\d+)?$/.test(text) ? Number(text) : NaN);
