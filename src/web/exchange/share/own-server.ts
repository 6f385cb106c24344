import { urlOf } from '../../session/visit/address';

/** A text of the page's own web server, or why it is not to be had, with what a message names. */
export type Fetched =
  | { readonly text: string; readonly url: string }
  | { readonly fault: 'badAddress' | 'noServer'; readonly values: { readonly address: string } }
  | { readonly fault: 'foreign'; readonly values: { readonly host: string } }
  | { readonly fault: 'notThere'; readonly values: { readonly address: string; readonly status: number } }
  | { readonly fault: 'notReached' | 'tooLarge'; readonly values: { readonly address: string } };

/**
 * Fetches a text from the page's own web server alone: its content policy lets it reach no other. Never rejects.
 *
 * @param base the address from which `given` is seen
 * @param most characters that are taken
 */
export async function fetchOwn(given: string, base: string, most: number): Promise<Fetched> {
  const url = urlOf(given, base);
  if (url === null) return { fault: 'badAddress', values: { address: given } };
  if (!/^https?:$/.test(location.protocol)) return { fault: 'noServer', values: { address: given } };
  if (url.origin !== location.origin) return { fault: 'foreign', values: { host: url.host || given } };
  const address = url.pathname;
  try {
    const response = await fetch(url, { cache: 'no-cache' });
    if (!response.ok) return { fault: 'notThere', values: { address, status: response.status } };
    const text = await response.text();
    return text.length > most ? { fault: 'tooLarge', values: { address } } : { text, url: url.href };
  } catch {
    return { fault: 'notReached', values: { address } };
  }
}

/** The page's address without what is behind `#`. */
export const pageAddress = (): string => location.href.replace(/#.*/, '');

/** Decodes an address; one that was written plainly may have a `%` of its own. */
export function decodedAddress(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
