/** A link in a text, and who it is from. */
export interface NamedLink {
  /** Empty: nobody says. */
  readonly name: string;
  readonly address: string;
}

/** Files in which links are looked for. */
export const isTextWithLinks = (file: string): boolean => /\.(txt|eml|md|csv|html?|url)$/i.test(file);

/** An address of a project or a program, or only the part of it from `#` on. */
const ADDRESS = /(?:https?:\/\/[^\s<>"']+|#p=\d{1,9}\.[\w-]+=*)/gi;

/** Chosen: a name stands on the line of its link or before it, and is short. */
const NAME_CHARACTERS = 60;

/** The links in a file, by its ending: a table, a page, or a text such as a whole e-mail. */
export function linksInFile(file: string, text: string): readonly NamedLink[] {
  if (/\.csv$/i.test(file)) return linksInTable(text);
  return linksIn(/\.html?$/i.test(file) ? textOfPage(text) : text);
}

/**
 * The links in a text, whatever stands around them. The name of a link is what stands before it on its line, else on the
 * line before; empty where nothing does. Addresses that lead somewhere else are left out.
 */
export function linksIn(text: string): readonly NamedLink[] {
  const links: NamedLink[] = [];
  let before = '';
  for (const line of text.split(/\r?\n/)) {
    let from = 0;
    for (const { address, start, end } of addressesIn(line)) {
      const name = nameIn(line.slice(from, start)) || nameIn(before);
      links.push({ name, address });
      [from, before] = [end, ''];
    }
    if (from > 0) before = '';
    else if (line.trim() !== '') before = line;
  }
  return links;
}

function addressesIn(
  line: string,
): readonly { readonly address: string; readonly start: number; readonly end: number }[] {
  return Array.from(line.matchAll(ADDRESS), (match) => ({
    address: match[0].replace(/[.,;:)\]}!?]+$/, ''),
    start: match.index,
    end: match.index + match[0].length,
  })).filter(({ address }) => /[#?&](p=\d|code=)/.test(address));
}

/** The words without what parts them from the link. */
function nameIn(text: string): string {
  const words = text.replace(/^[\s\-*•<>|"'([{,;]+|[\s\-–:=<>|"'([{,;]+$/g, '').trim();
  return words.length > NAME_CHARACTERS ? '' : words;
}

/** The links of a table, such as the answers to a form: the name is in the last cell before the link that is not empty. */
function linksInTable(text: string): readonly NamedLink[] {
  const links: NamedLink[] = [];
  for (const row of rowsOf(text)) {
    let before = '';
    for (const cell of row) {
      const found = addressesIn(cell);
      for (const { address } of found) links.push({ name: nameIn(before), address });
      if (found.length === 0 && cell.trim() !== '') before = cell;
    }
  }
  return links;
}

/** The cells of a table (RFC 4180), parted by whichever of comma, semicolon and tab is the most frequent in its first line. */
function rowsOf(text: string): readonly (readonly string[])[] {
  const [head = ''] = text.split('\n', 1);
  const [sign = ','] = [',', ';', '\t'].toSorted((a, b) => head.split(b).length - head.split(a).length);
  const rows: string[][] = [];
  let row: string[] = [];
  for (const [, quoted, plain = '', end] of text.matchAll(cellOf(sign))) {
    row.push(quoted?.replaceAll('""', '"') ?? plain);
    if (end === sign) continue;
    rows.push(row);
    row = [];
  }
  return rows;
}

/** A cell and what ends it. */
const cellOf = (sign: string): RegExp => new RegExp(`(?:"((?:[^"]|"")*)"|([^${sign}\\r\\n]*))(${sign}|\\r?\\n|$)`, 'g');

/** What is read on a page, with the addresses of its links. */
function textOfPage(html: string): string {
  return html
    .replace(/<a\b[^>]*?\bhref\s*=\s*["']?([^"'\s>]+)[^>]*>([\s\S]*?)<\/a>/gi, (_, address: string, shown: string) =>
      // Where the address itself is shown it would be there twice.
      /https?:|#p=/i.test(shown) ? ` ${address} ` : `${shown} ${address} `,
    )
    .replace(/<\/(?:p|div|li|tr|h\d)>|<br\b[^>]*>/gi, '\n')
    .replace(/<[^>]*>/g, ' ')
    .replace(/&(amp|lt|gt|quot|nbsp|#39);/g, (_, name: string) => entities[name] ?? ' ');
}

const entities: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };
