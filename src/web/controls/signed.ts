/** A number as people read it: with the minus sign, which is as wide as a plus, instead of the hyphen. */
export const signed = (value: number): string => String(value).replace('-', '\u2212');
