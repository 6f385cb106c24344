/** The meaning of WebTigerPython's settings here, whether they come in an address or in a message. */
import { LANGUAGES, type Language } from '#core/languages';

import { PARTS, type Part } from '../simulator';

/** Longest layout that is read as text, in characters. Chosen: no layout of three panes comes near. */
export const LAYOUT_CHARACTERS = 1000;

/** Approximate number of values of a layout that are read, including lists. Chosen: three nested panes are a dozen. */
const LAYOUT_VALUES = 200;

/** WebTigerPython's panes and our parts in their places. */
const PANES: Readonly<Record<string, readonly Part[]>> = {
  Editor: ['code'],
  Canvas: ['board', 'arena'],
  Console: ['console'],
};

/** The shown parts when the picture fills everything. */
export const PICTURE: readonly Part[] = ['board', 'arena'];

/**
 * The parts that a layout shows, with the bar: `["Editor","Canvas"]`, nested at will, as a list or as its JSON. The
 * names of the panes count; the page decides where they go.
 *
 * @returns `null` if it has no pane
 */
export function partsOfLayout(layout: unknown): readonly Part[] | null {
  const names = namesIn(typeof layout === 'string' ? valueOf(layout) : layout);
  const parts = Object.entries(PANES).flatMap(([name, own]) => (names.includes(name) ? own : []));
  return parts.length === 0 ? null : PARTS.filter((part) => part === 'bar' || parts.includes(part));
}

/** The entries of a nested list. Lists may contain themselves or each other: reading stops after a number of values. */
function namesIn(layout: unknown): readonly unknown[] {
  const values = [layout];
  for (let place = 0; place < values.length && values.length < LAYOUT_VALUES; place += 1) {
    const value = values[place];
    if (Array.isArray(value)) values.push(...(value as readonly unknown[]).slice(0, LAYOUT_VALUES));
  }
  return values;
}

function valueOf(json: string): unknown {
  if (json.length > LAYOUT_CHARACTERS) return null;
  try {
    return JSON.parse(json);
  } catch {
    return json;
  }
}

/** A boolean or its text: `dark_mode=true`, or `dark_mode` alone. @returns `undefined` for anything else */
export function flagOf(value: unknown): boolean | undefined {
  if (value === true || value === '' || value === 'true' || value === '1') return true;
  return value === false || value === 'false' || value === '0' ? false : undefined;
}

/** A language by its tag, such as `de` or `de-CH`. @returns `undefined` for a language that we do not have */
export function languageOf(tag: string): Language | undefined {
  const [language] = tag.toLowerCase().split(/[-_]/);
  return LANGUAGES.find((one) => one === language);
}
