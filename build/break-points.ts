/** The widths at which the page changes its form, by name: `@media (--phone)`, and `@media not (--phone)` for all above. */
import type { CSSOptions } from 'vite';

type PostcssPlugin = NonNullable<Exclude<CSSOptions['postcss'], string | undefined>['plugins']>[number];

/** The media condition of each name. */
export const BREAK_POINTS: Readonly<Record<string, string>> = {
  /** A phone upright: one column. */
  phone: '(max-width: 599px)',
  /** A small tablet upright, a phone on its side: what is beside something else comes below it. */
  narrow: '(max-width: 767px)',
  /** A tablet upright: columns at the side come below. */
  tablet: '(max-width: 1023px)',
  /** Only one pane has room: a phone either way, a window as low as a phone. */
  'one-pane': '(max-width: 599px), (max-height: 439px), (max-width: 1000px) and (max-height: 599px)',
};

/** The conditions of a media rule with widths in the place of names. */
export const withWidths = (conditions: string): string =>
  conditions.replace(/(\bnot\s+)?\(--([\w-]+)\)/g, (_, not: string | undefined, name: string) => {
    const widths = BREAK_POINTS[name];
    if (widths === undefined) throw new Error(`There is no break point ${name}.`);
    if (not === undefined) return widths;
    if (widths.includes(',')) throw new Error(`The break point ${name} cannot be turned round.`);
    return `not all and ${widths}`; // without `all and` only Chrome 104 understands it
  });

/** Lets stylesheets name break points. */
export const breakPoints = {
  postcssPlugin: 'break-points',
  AtRule: {
    media(rule: { params: string }): void {
      const params = withWidths(rule.params);
      if (params !== rule.params) rule.params = params;
    },
  },
} as PostcssPlugin;
