/** Parameters that carry work: a program (WebTigerPython's, or one in a course of ours), or a course. */
export const LINK_PARAMETERS = ['code', 'fs', 'playground', 'world', 'task'] as const;
