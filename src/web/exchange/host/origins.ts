/** Name of the `<meta>` in which the server of the page lists the origins that may command it, separated by spaces. */
export const ORIGINS_META = 'parcours-origins';

/**
 * The origins that may command the page: those listed by the page itself, narrowed to those that its address names.
 * Whoever embeds the page writes the address, so it can only narrow.
 *
 * @param ofPage content of the page's `<meta>`; `null`: there is none, and any parent may
 * @param ofAddress what the address names; empty: it says nothing
 * @returns `null`: any
 */
export function allowedOrigins(ofPage: string | null, ofAddress: readonly string[]): readonly string[] | null {
  const named = ofPage === null ? null : ofPage.split(/\s+/).filter(Boolean).map(plainOrigin);
  if (ofAddress.length === 0) return named;
  const narrowed = ofAddress.map(plainOrigin);
  return named === null ? narrowed : named.filter((origin) => narrowed.includes(origin));
}

/**
 * The origin of an address, so that a trailing slash does no harm. Any other text stays as it is; of such texts only
 * `null` can match.
 */
function plainOrigin(text: string): string {
  if (text === 'null' || !URL.canParse(text)) return text;
  const { origin } = new URL(text);
  return origin === 'null' ? text : origin; // only the text `null` itself names the origin `null`
}
