/**
 * An origin in the form for sending a message to it. An opaque one (`null`: a sandbox, a file) or an unknown one cannot
 * be named: the message then goes to any receiver.
 */
export const targetOrigin = (origin: string | null): string => (origin === null || origin === 'null' ? '*' : origin);
