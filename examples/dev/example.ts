/** What an example says, a line at a time. */
export type Print = (line: string) => void;
