import type { Language } from './texts';

/** Every language by its own name. */
export const languageNames: Readonly<Record<Language, string>> = { de: 'Deutsch', en: 'English' };
