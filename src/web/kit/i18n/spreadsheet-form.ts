import { formWith, usualForm, type SpreadsheetForm } from '#core/csv';
import type { Language } from '#core/languages';

/**
 * The signs that spreadsheets expect in a language on this device: its country says which decimal sign they have.
 *
 * @param tags the languages of the device, such as `de-CH`
 */
export function spreadsheetForm(language: Language, tags: readonly string[] = navigator.languages): SpreadsheetForm {
  const here = tags.find((tag) => tag.toLowerCase().startsWith(`${language}-`));
  if (here === undefined) return usualForm(language);
  return formWith(language, new Intl.NumberFormat(here).format(0.5).charAt(1) === ',' ? ',' : '.');
}
