import { languages, type Texts } from '#core/texts';
import { inEvery } from '#core/words';

/** Every language by its own name. */
export const languageNames: Texts = inEvery((language) => languages[language].name);
