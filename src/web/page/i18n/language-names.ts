import type { Texts } from '#core/texts';

/** Every language by its own name. */
export const languageNames: Texts = { de: 'Deutsch', fr: 'Français', it: 'Italiano', en: 'English' };
