/**
 * The tag of a test that one engine answers for all three: it shows what the page does with a click or a key, not how an
 * engine hands them over. Pointer, keyboard, focus, storage, workers, frames, sound and sameness run in every engine.
 */
export const IN_ONE_ENGINE = { tag: '@chromium' } as const;
