import type { ReferenceContext } from './context';
import { itemOf, type Item } from './item';
import { boardModules } from './modules/index';
import type { Entry, Names, ReferenceModule } from './types';

/** The meaning of a name or an expression. */
export interface Meaning {
  readonly item: Item;
  /** The names behind its dot. */
  names(): ReadonlyMap<string, () => Meaning>;
  /** The meaning of its return value; `null` if unknown. */
  called(): Meaning | null;
  /** The type of its elements, for `for` and for [ ]. */
  element(): Meaning | null;
}

export type MeaningNames = ReadonlyMap<string, () => Meaning>;
const NO_NAMES: MeaningNames = new Map();

/** The meaning of something about which nothing more is known. */
export const opaque = (item: Item): Meaning => ({
  item,
  names: () => NO_NAMES,
  called: () => null,
  element: () => null,
});

/** The same value under another name, such as that of a variable. */
export const renamed = (meaning: Meaning, item: Item): Meaning => ({
  item,
  names: () => meaning.names(),
  called: () => meaning.called(),
  element: () => meaning.element(),
});

/** The API of one board: its modules, its types and the built-in names. */
export class Reference {
  private readonly modules: readonly ReferenceModule[];

  constructor(private readonly context: ReferenceContext) {
    this.modules = [...boardModules, ...context.modules].filter(
      ({ boards }) => boards === undefined || boards.includes(context.board),
    );
  }

  /** The modules that `import` can load, by name. */
  importable(): MeaningNames {
    const names = new Map<string, () => Meaning>();
    for (const module of this.modules) {
      if (module.name === 'builtins') continue;
      for (const name of [module.name, ...module.aliases]) {
        if (!names.has(name)) names.set(name, () => this.moduleMeaning(name, module));
      }
    }
    return names;
  }

  /** The module that `import name` would load; `null` for none. */
  module(name: string): Meaning | null {
    const found = this.moduleNamed(name);
    return found === null ? null : this.moduleMeaning(name, found);
  }

  builtins(): MeaningNames {
    return this.module('builtins')?.names() ?? NO_NAMES;
  }

  /** A value of a type written as in a module's table, such as `list[Image]`. */
  instance(type: string, home: ReferenceModule | null = null, item?: Item): Meaning | null {
    const { base, inner } = parseType(type);
    const found = this.typeNamed(base, home);
    if (found === null) return null;
    const { entry, key, module } = found;
    return {
      item: item ?? itemOf({ label: base, kind: 'value', type, text: entry.text ?? key, home: module.name }),
      names: () => sorted(this.typeNames(found), (it) => it === 'function'),
      called: () => null,
      element: () => {
        const element = inner ?? ELEMENTS[base];
        return element === undefined ? null : this.instance(element, home);
      },
    };
  }

  private moduleNamed(name: string): ReferenceModule | null {
    return this.modules.find((it) => it.name === name || it.aliases.includes(name)) ?? null;
  }

  private moduleMeaning(name: string, module: ReferenceModule): Meaning {
    const item = itemOf({ label: name, kind: 'module', text: module.name });
    const names = (): MeaningNames => this.entryNames(module.names, module, keyOf(module), name);
    return { item, names, called: () => null, element: () => null };
  }

  private entryNames(names: Names, module: ReferenceModule, key: string, home: string): MeaningNames {
    const found = new Map<string, () => Meaning>();
    for (const [name, entry] of Object.entries(names)) {
      if (entry.boards !== undefined && !entry.boards.includes(this.context.board)) continue;
      found.set(name, () => this.entryMeaning(name, entry, module, `${key}.${name}`, home));
    }
    return found;
  }

  private entryMeaning(label: string, entry: Entry, module: ReferenceModule, key: string, home: string): Meaning {
    const item = itemOf({
      label,
      kind: entry.kind,
      calls: entry.calls,
      type: entry.kind === 'value' ? entry.type : null,
      text: entry.text ?? key,
      home: home === 'builtins' ? null : home,
      missing: this.missing(entry),
      limits: entry.limits ?? {},
    });
    const plain = opaque(item);
    switch (entry.kind) {
      case 'value':
        return this.instance(entry.type ?? '', module, item) ?? plain;
      case 'object':
        return { ...plain, names: () => this.entryNames(entry.members, module, key, `${home}.${label}`) };
      case 'module': {
        const meaning = this.module(entry.type ?? '');
        return meaning === null ? plain : renamed(meaning, item);
      }
      case 'function':
        return { ...plain, called: () => this.instance(resultOf(entry.calls[0] ?? ''), module) };
      case 'type':
      case 'exception':
        return {
          ...plain,
          names: () => sorted(this.typeNames({ entry, key, module, name: label }), (it) => it === 'value'),
          called: () => this.instance(label, module),
        };
      case 'keyword':
        return plain;
    }
  }

  private missing(entry: Entry): Item['missing'] {
    if (entry.absent === true) return 'absent';
    return entry.feature === undefined || this.context.features.includes(entry.feature) ? null : entry.feature;
  }

  private typeNames({ entry, key, module, name }: FoundType): MeaningNames {
    const inherited = entry.bases.flatMap((base) => {
      const found = this.typeNamed(base, module);
      return found === null ? [] : [...this.typeNames(found)];
    });
    return new Map([...this.entryNames(entry.members, module, key, name), ...inherited]);
  }

  private typeNamed(name: string, home: ReferenceModule | null): FoundType | null {
    const dot = name.indexOf('.');
    const homes = dot < 0 ? [home, this.moduleNamed('microbit'), this.moduleNamed('builtins')] : [];
    if (dot >= 0) homes.push(this.moduleNamed(name.slice(0, dot)));
    const last = name.slice(dot + 1);
    for (const module of homes) {
      const entry = module?.names[last];
      if (module && entry !== undefined && (entry.kind === 'type' || entry.kind === 'exception')) {
        return { entry, key: `${keyOf(module)}.${last}`, module, name: last };
      }
    }
    return null;
  }
}

/** Puts what is needed most often first: an object's functions, a type's constants. */
function sorted(names: MeaningNames, first: (kind: Item['kind']) => boolean): MeaningNames {
  const all = [...names].map(([name, meaning]) => ({
    pair: [name, meaning] as const,
    early: first(meaning().item.kind),
  }));
  return new Map([...all.filter((it) => it.early), ...all.filter((it) => !it.early)].map((it) => it.pair));
}

interface FoundType {
  readonly entry: Entry;
  readonly key: string;
  readonly module: ReferenceModule;
  readonly name: string;
}

/** The types of the elements of built-in types whose own names do not say it. */
const ELEMENTS: Readonly<Record<string, string>> = {
  str: 'str',
  bytes: 'int',
  bytearray: 'int',
  range: 'int',
  file: 'str',
};

/** Prefix of the keys of a module's words: both boards' modules say the same about the same names. */
export const keyOf = ({ name }: ReferenceModule): string =>
  name === 'calliopemini' || name === 'calliope_mini' ? 'microbit' : name;

/** `list[Image] | None` → list, of Image. */
function parseType(type: string): { base: string; inner: string | undefined } {
  const first = type.replace(/ \|.*$/, '');
  const bracket = first.indexOf('[');
  if (bracket < 0) return { base: first, inner: undefined };
  return {
    base: first.slice(0, bracket),
    inner: first
      .slice(bracket + 1, -1)
      .split(',')[0]
      ?.trim(),
  };
}

/** The return type: what follows the arrow. */
export function resultOf(call: string): string {
  const arrow = call.lastIndexOf(') -> ');
  return arrow < 0 ? '' : call.slice(arrow + 5);
}
