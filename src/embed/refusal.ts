/** `null` on success. Otherwise one English sentence that names the place and the value; nothing has changed then. */
export type Refusal = string | null;
