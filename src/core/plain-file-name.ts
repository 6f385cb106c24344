/**
 * A name for a file or an address that every server and app takes: letters without marks, digits and `-`; empty if nothing
 * of it is left.
 *
 * @param most the most characters
 */
export const plainFileName = (name: string, most: number): string =>
  name
    .normalize('NFKD')
    .toLowerCase()
    .replace(/\p{M}/gu, '')
    .replace(/[^a-z0-9]+/g, '-')
    .slice(0, most)
    .replace(/^-|-$/g, '');
