/**
 * The tag of a test that one engine answers for all three: it shows what the page does with a click, a key or a message,
 * not how an engine hands them over. In every engine run: one test of each sort of pointer, keyboard and focus, storage,
 * workers, frames and their messages, sound, offline, sameness, and one whole visit (`first-steps`).
 */
export const IN_ONE_ENGINE = { tag: '@chromium' } as const;
