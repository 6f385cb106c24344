/** Exceptions about a name, which their message has in quotation marks as the last one. */
const ABOUT_NAMES: readonly string[] = ['NameError', 'AttributeError', 'ImportError', 'ModuleNotFoundError'];

/** The name that an exception says is unknown; `null`: it is about something else. */
export function missingName({ type, message }: { readonly type: string; readonly message: string }): string | null {
  if (!ABOUT_NAMES.includes(type)) return null;
  const marked = Array.from(message.matchAll(/'([\p{L}\d_]+)'/gu), ([, name]) => name).at(-1);
  return marked ?? /\bname ([\p{L}\d_]+)$/u.exec(message)?.[1] ?? null; // `can't import name x` has no marks
}

/** The places of a name in a line of code, as columns of its first letter. */
export const placesOf = (name: string, line: string): readonly number[] =>
  Array.from(line.matchAll(/[\p{L}\d_]+/gu))
    .filter(([word]) => word === name)
    .map(({ index }) => index);
