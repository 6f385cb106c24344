/** Attributes that the page's address takes under the same names. */
const PARAMETERS = ['show', 'lang', 'theme', 'speed', 'robot', 'board', 'seed', 'reality', 'world', 'task'] as const;

/** Attributes that have an effect by being there. `false` is what frameworks write for "not there". */
export const isOn = (value: string | null): boolean => value !== null && value !== 'false';

/** What an element says: the value of an attribute, or `null`. */
export type Attributes = (name: string) => string | null;

/**
 * The address that the element's frame shows: that of Parcours with what the attributes wish.
 *
 * @param base address of the host page, for a relative `src`
 * @returns `null`: there is no `src`, or it is no address of a page (`javascript:` and the like)
 */
export function pageAddress(attribute: Attributes, base: string): string | null {
  const src = attribute('src') ?? '';
  if (src === '' || !URL.canParse(src, base)) return null;
  const url = new URL(src, base);
  if (/^(javascript|data|blob|about):$/.test(url.protocol)) return null;
  if (isOn(attribute('sandboxed'))) url.pathname = singleFile(url.pathname);
  for (const name of PARAMETERS) {
    const value = attribute(name);
    if (value !== null) url.searchParams.set(name, value);
  }
  if (isOn(attribute('muted'))) url.searchParams.set('muted', 'true');
  // The element speaks the page's own dialect: no other has to be said unasked.
  if (!url.searchParams.has('dialect')) url.searchParams.set('dialect', 'none');
  return url.href;
}

/** The form of a page that starts in a plain sandbox (decision 0018); a name of the host's own stays. */
function singleFile(path: string): string {
  if (path.endsWith('.single.html')) return path;
  return path
    .replace(/\/(index\.html)?$/, '/parcours.single.html')
    .replace(/\/simulator\.html$/, '/simulator.single.html');
}
