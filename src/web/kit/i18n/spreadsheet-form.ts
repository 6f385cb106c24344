import { formWith, usualForm, type SpreadsheetForm } from '#core/csv';
import type { Language } from '#core/languages';

/** Switzerland and Liechtenstein: spreadsheets have a decimal point there in all languages, also in French, which is written with a comma. */
const WITH_POINT = { zones: ['Europe/Zurich', 'Europe/Vaduz'], tag: /-(CH|LI)$/i };

/**
 * The signs that spreadsheets expect in a language on this device: its country says which decimal sign they have. The
 * country is that of its clock where that tells: a browser in French says `fr-FR` in Lausanne, too.
 *
 * @param tags the languages of the device, such as `de-CH`
 * @param zone the time zone of its clock
 */
export function spreadsheetForm(
  language: Language,
  tags: readonly string[] = navigator.languages,
  zone: string = new Intl.DateTimeFormat().resolvedOptions().timeZone,
): SpreadsheetForm {
  const here = tags.find((tag) => tag.toLowerCase().startsWith(`${language}-`));
  if (WITH_POINT.zones.includes(zone) || (here !== undefined && WITH_POINT.tag.test(here)))
    return formWith(language, '.');
  if (here === undefined) return usualForm(language);
  return formWith(language, new Intl.NumberFormat(here).format(0.5).charAt(1) === ',' ? ',' : '.');
}
