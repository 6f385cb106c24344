/** The output of an example, a line at a time. */
export type Print = (line: string) => void;
