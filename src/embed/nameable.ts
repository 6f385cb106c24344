/**
 * An origin as it is named when a message is sent to it. One that is none (`null`: a sandbox, a file) or is not known
 * cannot be named: then whoever is there hears it.
 */
export const nameable = (origin: string | null): string => (origin === null || origin === 'null' ? '*' : origin);
