import { slipIn } from './slips';
import { curlyAdvice, withMend, type Source, type SyntaxAdvice } from './syntax-advice';

/** Common misspellings of Python's three capitalised values and of its most used functions. */
const MEANT: Readonly<Record<string, string>> = {
  true: 'True', TRUE: 'True', wahr: 'True', vrai: 'True', vero: 'True',
  false: 'False', FALSE: 'False', falsch: 'False', faux: 'False', falso: 'False',
  none: 'None', NONE: 'None', null: 'None', NULL: 'None', nil: 'None', undefined: 'None',
}; // prettier-ignore
const FUNCTIONS = /^(?:print|input|range|len|int|str|float|list|round|abs|min|max|sum)$/;

/** The name that an unknown one was meant to be, if the name itself shows it. */
export function nameAdvice(type: string, message: string, { text, line }: Source): SyntaxAdvice | null {
  const name = type === 'NameError' ? (/^name '(.+)' (?:isn't|is not) defined/s.exec(message)?.[1] ?? null) : null;
  if (name === null) return null;
  const written = text.split('\n')[line - 1] ?? '';
  if (!/^[\p{L}_][\p{L}\d_]*$/u.test(name)) {
    if (/[“”„‘’«»‹›´`]/.test(name)) return curlyAdvice({ text, line });
    const slip = slipIn(written.trim(), written);
    const isSign = slip?.key === 'error.typedSign' || slip?.key === 'error.hiddenSign';
    return isSign ? withMend(slip, text, line) : null;
  }
  const change = (to: string): { line?: string } => {
    const found = written.match(new RegExp(`(?:^|[^\\w.])${name}(?!\\w)`, 'g')) ?? [];
    return found.length === 1 ? { line: written.replace(name, to) } : {};
  };
  const value = MEANT[name];
  if (value !== undefined) return withMend({ key: 'error.truthWord', values: { name, right: value }, ...change(value) }, text, line); // prettier-ignore
  const small = name.toLowerCase();
  if (small !== name && FUNCTIONS.test(small))
    return withMend({ key: 'error.keywordSmall', values: { name, right: small }, ...change(small) }, text, line);
  if (/^(?:exit|quit)$/.test(name)) return { key: 'error.noExit', values: { name } };
  if (new RegExp(`^\\s*${name}\\s*==`, 'u').test(written))
    return withMend({ key: 'error.assignOnce', values: { name }, line: written.replace('==', '=') }, text, line);
  if (new RegExp(`\\b(?:print|show|scroll)\\(\\s*${name}\\s*\\)`).test(written))
    return { key: 'error.textOrName', values: { name } };
  return null;
}
