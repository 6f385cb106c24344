import { shownLanguage } from '../../kit/i18n';
import { decimalSign, numberText } from '../../kit/i18n/number-text';
import type { AxisTexts } from './plot/chart-plot';

/** As many decimals as a step needs. */
const decimalsFor = (step: number): number => Math.min(4, Math.max(0, Math.ceil(-Math.log10(step || 1) - 1e-9)));

/** The value of a curve with its unit; a dash where it has none. */
export function valueText(value: number | null, unit: string): string {
  if (value === null) return '–';
  const size = Math.abs(value);
  const text = numberText(value, shownLanguage(), Number.isInteger(value) || size >= 1000 ? 0 : size >= 100 ? 1 : 2);
  const short = text.replace(/([.,]\d*?)0+$/, '$1').replace(/[.,]$/, '');
  return unit === '' || unit === '0/1' ? short : `${short} ${unit}`;
}

/** Seconds, from a minute on with minutes: `4`, `1:05`. */
export function secondsText(seconds: number, step: number): string {
  const decimals = decimalsFor(step);
  const minutes = Math.floor(seconds / 60 + 1e-9);
  const rest = Math.max(0, seconds - 60 * minutes).toFixed(decimals);
  const text = minutes === 0 ? rest : `${minutes}:${rest.padStart(decimals === 0 ? 2 : decimals + 3, '0')}`;
  return text.replace('.', decimalSign(shownLanguage()));
}

/** The numbers beside the axes of a chart over time. */
export const timeAxes: AxisTexts = {
  across: (value, step) => (value === 0 ? '0 s' : secondsText(value, step)),
  up: (value, step) => numberText(value, shownLanguage(), decimalsFor(step)),
};
