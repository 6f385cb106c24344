import { keyOf } from './meaning';
import { boardModules } from './modules/index';
import { keywords } from './modules/keywords';
import type { Entry, ReferenceModule } from './types';

/** The keys of all words that these modules need: `microbit`, `microbit.display`, `microbit.display.show`. */
export function textKeysOf(modules: readonly ReferenceModule[]): Set<string> {
  const keys = new Set<string>();
  const add = (key: string, entry: Entry): void => {
    keys.add(entry.text ?? key);
    for (const [name, member] of Object.entries(entry.members)) add(`${key}.${name}`, member);
  };
  for (const module of modules) {
    keys.add(module.name);
    for (const [name, entry] of Object.entries(module.names)) add(`${keyOf(module)}.${name}`, entry);
  }
  return keys;
}

/** The keys of all words on the boards' modules and on the language. */
export function allTextKeys(): Set<string> {
  const keys = textKeysOf(boardModules);
  for (const word of Object.keys(keywords)) keys.add(`keyword.${word}`);
  return keys;
}
