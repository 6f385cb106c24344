import { localeOf } from '../../kit/i18n/locale';
import { dateText } from '../../kit/i18n/number-text';
import { t } from '../../kit/i18n';
import type { Language } from '../../kit/i18n/texts';
import words from './words';

/** A time as people say it: `today, 09:58`, `yesterday, 17:20`, and with the date before that. */
export function whenText(atMs: number, nowMs: number, language: Language): string {
  const time = new Date(atMs).toLocaleTimeString(localeOf(language), { hour: '2-digit', minute: '2-digit' });
  const daysAgo = Math.round((midnight(nowMs) - midnight(atMs)) / DAY_MS);
  if (daysAgo === 0) return t(words.today, { time });
  if (daysAgo === 1) return t(words.yesterday, { time });
  return dateText(atMs, language);
}

const DAY_MS = 24 * 3600 * 1000;

/** The midnight before a time, where the reader is. */
function midnight(ms: number): number {
  const day = new Date(ms);
  day.setHours(0, 0, 0, 0);
  return day.getTime();
}
