/** The parameters of WebTigerPython's links, in the query (`?code=…`) or behind `#?`. */
import { namesTogether, note, shortName, type Note } from './note';
import { deviceCalled } from './device-names';

/** The parameters by name, the first of each; `null`: its value cannot be decoded. */
export type Parameters = ReadonlyMap<string, string | null>;

/** Parameters that say what a page looks like: whoever opens a link decides that anew. */
const LAYOUT: ReadonlySet<string> = new Set([
  'layout',
  'lang',
  'dark_mode',
  'hide_topbar',
  'full_screen',
  'tutorial_size',
]);

/** Parameters that are understood here or by the page (`#web/session/visit/address`). */
const TAKEN: ReadonlySet<string> = new Set([
  ...['code', 'device', 'playground'],
  ...['show', 'board', 'robot', 'task', 'world', 'seed', 'reality', 'speed', 'theme', 'muted', 'dialect', 'origin'],
  ...['color', 'flag', 'mode'],
]);

/** Parameters that platforms and search machines append to any link. */
const APPENDED = /^(utm_\w*|fbclid|gclid|msclkid|mc_[ce]id)$/;

/** Values that turn something off. */
const OFF: ReadonlySet<string> = new Set(['', 'false', '0', 'null', '[]', '{}']);

/** Reads the query and the fragment of a whole address, or one of them. A `+` stays: it is a sign of base64. */
export function parametersOf(address: string): Parameters {
  const parameters = new Map<string, string | null>();
  for (const part of address.split(/[?&#]/)) {
    const [, name, value = ''] = /^([^=/:]+)=(.*)$/s.exec(part) ?? [];
    if (name !== undefined && !parameters.has(name)) parameters.set(name, decoded(value));
  }
  return parameters;
}

function decoded(value: string): string | null {
  try {
    return decodeURIComponent(value);
  } catch {
    return null;
  }
}

/** A note on an unknown device, and one on all parameters that mean something here unknown. */
export function notesOfParameters(parameters: Parameters): readonly Note[] {
  const device = parameters.get('device') ?? '';
  const isUnknown = device !== '' && deviceCalled(device) === null;
  const strange = Array.from(parameters.keys()).filter((name) => saysMore(name, parameters));
  return [
    ...(isUnknown ? [note('device', { device: shortName(device) })] : []),
    ...(strange.length > 0 ? [note('parameters', { names: namesTogether(strange) })] : []),
  ];
}

/** True if a parameter has a meaning that Parcours does not take. */
function saysMore(name: string, parameters: Parameters): boolean {
  if (OFF.has(parameters.get(name) ?? '') || LAYOUT.has(name) || TAKEN.has(name) || APPENDED.test(name)) return false;
  return name !== 'fs' || (parameters.get('code') ?? '') !== '';
}
