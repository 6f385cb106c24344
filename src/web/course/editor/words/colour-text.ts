import type { ColourState } from '#robots/robot';
import { valueText } from './value-text';

/** The hue says nothing about these. */
const WITHOUT_HUE: readonly ColourState['name'][] = ['white', 'gray', 'black'];

/** The sight of a colour sensor in words: the colour, and its hue in degrees where that says something. */
export const colourText = ({ name, hue }: Pick<ColourState, 'name' | 'hue'>): string =>
  WITHOUT_HUE.includes(name) ? valueText(name) : `${valueText(name)} ${String(hue)}°`;
