/**
 * Features that the oldest browsers (`scripts/oldest.mjs`) lack and no tool lowers: units get an older one in front, and a build with
 * anything else of it fails, wherever it comes from.
 */
import type { CSSOptions, Plugin } from 'vite';

type PostcssPlugin = NonNullable<Exclude<CSSOptions['postcss'], string | undefined>['plugins']>[number];

/** `100dvh` needs Chrome 108 or Safari 15.4; in front of it stands the same with `vh`. */
export const olderUnits = {
  postcssPlugin: 'older-units',
  Declaration(declaration: { readonly value: string; cloneBefore(changes: { value: string }): unknown }): void {
    const older = declaration.value.replace(/(?<=\d)[dsl](?=v[hw]\b(?!-))/g, '');
    if (older !== declaration.value) declaration.cloneBefore({ value: older });
  },
} as PostcssPlugin;

/** Constructs that a script must not contain: pattern and name. */
const NOT_IN_SCRIPTS: readonly (readonly [RegExp, string])[] = [
  [/\(\?<[=!]/, 'a regular expression that looks behind (Safari 16.4)'],
  [/\bstructuredClone\(/, 'structuredClone (Chrome 98)'],
  [/\.randomUUID\(/, 'crypto.randomUUID (secure pages only)'],
  [/\b(Object|Map)\.groupBy\(|Promise\.withResolvers\(|Array\.fromAsync\(/, 'a function of 2024'],
  [/\.(toWellFormed|isWellFormed)\(|\bIterator\.from\(/, 'a method of 2024'],
  [/AbortSignal\.(any|timeout)\(/, 'AbortSignal.any or timeout (Chrome 103)'],
  [/new (OffscreenCanvas|(C|Dec)ompressionStream)\b/, 'OffscreenCanvas or CompressionStream (Safari 16.4)'],
  [/\bstatic\s*\{/, 'a static block (Chrome 94)'],
];

/** Constructs that styles must not contain at all. */
const NOT_IN_STYLES: readonly (readonly [RegExp, string])[] = [
  [/@layer\b/, '@layer (Chrome 99): all in it would be left out'],
  [/@media[^{]*[<>]/, 'a range in @media (Chrome 104)'],
  [/:has\(/, ':has() (Firefox 121)'],
  [/(^|[{;])(translate|rotate|scale):/, 'translate, rotate or scale of their own (Chrome 104)'],
];

/** Values that need one in front that is understood everywhere. With a variable in it even that would not help. */
const NEW_VALUE = /color-mix\(|\b[\d.]+[dsl]v[hw]\b/;

/** The constructs of a script that the oldest browsers lack. */
export const missingInScript = (code: string): readonly string[] =>
  NOT_IN_SCRIPTS.filter(([look]) => look.test(code)).map(([, name]) => name);

/** The constructs of styles that the oldest browsers lack and cannot do without. */
export function missingInStyles(css: string): readonly string[] {
  const found = NOT_IN_STYLES.filter(([look]) => look.test(css)).map(([, name]) => name);
  for (const [, rule = ''] of css.matchAll(/\{([^{}]*)\}/g)) {
    const known = new Set<string>();
    for (const declaration of rule.split(';')) {
      const [, property = '', value = ''] = /^\s*([\w-]+)\s*:(.*)$/s.exec(declaration) ?? [];
      if (!NEW_VALUE.test(value)) known.add(property);
      else if (!known.has(property)) found.push(`${property}:${value} with no older value in front`);
      else if (value.includes('var(')) found.push(`${property}:${value}: with a variable no older value counts`);
    }
  }
  return found;
}

/** Lets a build fail that the oldest browsers could not run. */
export function runsInTheOldest(): Plugin {
  return {
    name: 'runs-in-the-oldest',
    apply: 'build',
    enforce: 'post',
    generateBundle(_, bundle) {
      for (const [name, part] of Object.entries(bundle)) {
        const missing =
          part.type === 'chunk'
            ? missingInScript(part.code)
            : name.endsWith('.css')
              ? missingInStyles(part.source.toString())
              : [];
        if (missing.length > 0) this.error(`${name} needs what the oldest browsers lack: ${missing.join('; ')}.`);
      }
    },
  };
}
