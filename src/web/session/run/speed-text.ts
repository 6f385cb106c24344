import type { Speed } from '#simulation/pace';
import { shownLanguage, t } from '../../kit/i18n';
import { numberText } from '../../kit/i18n/number-text';

const FRACTIONS = new Map<Speed, string>([
  [0.25, '¼'],
  [0.5, '½'],
]);

/** A speed as pupils read it: `¼×`, `2×`, `max`. */
export function speedName(speed: Speed): string {
  return speed === 'max' ? t('bar.speedMax') : `${FRACTIONS.get(speed) ?? speed}×`;
}

/** A factor with as many digits as make sense: `0.62`, `1.9`, `34`, as the language writes them. */
export function factorText(factor: number): string {
  const decimals = factor < 0.95 ? 2 : factor < 9.95 ? 1 : 0;
  return numberText(factor, shownLanguage(), decimals);
}

/** True if the machine is too slow: more than a tenth below the chosen speed. */
export function isTooSlow(speed: Speed, achieved: number | null): boolean {
  return speed !== 'max' && achieved !== null && achieved < speed * 0.9;
}
