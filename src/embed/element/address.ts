/** Attributes that have the same names in the page's address. */
const PARAMETERS = ['show', 'lang', 'theme', 'speed', 'robot', 'board', 'seed', 'reality', 'world', 'task'] as const;

/** True if an attribute that takes effect by its presence is there. Frameworks write `false` for absence. */
export const isOn = (value: string | null): boolean => value !== null && value !== 'false';

/** The value of an attribute of the element, or `null`. */
export type Attributes = (name: string) => string | null;

/**
 * The address for the element's frame: that of Parcours with the wishes of the attributes.
 *
 * @param base address of the host page, for a relative `src`
 * @returns `null` if `src` is missing or not the address of a page (`javascript:` and the like)
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
  // The element uses the page's own dialect: the page needs to speak no other before it is asked.
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
