import { formatOf } from './formats';
import { readMail } from './mail';

/** A link in a text, and the name of the person it is from. */
export interface NamedLink {
  /** Empty: none stands beside it. */
  readonly name: string;
  readonly address: string;
}

/** A web address, or the part from `#` on of a link of a project or a run. */
const ADDRESS = /(?:https?:\/\/[^\s<>"']+|#(?:p=\d{1,9}|r=\d{1,9}\.\d{1,12})\.[\w-]+=*)/gi;

/** The longest text that is taken for a name. Chosen: names are short. */
const NAME_CHARACTERS = 60;

/** The links in a file, by its ending: a table, a page, or a text such as a whole e-mail. */
export function linksInFile(file: string, text: string): readonly NamedLink[] {
  const format = formatOf(file);
  if (format === 'table') return linksInTable(text);
  if (format === 'mail') return linksInMail(text);
  return linksIn(format === 'page' ? textOfPage(text) : text);
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

/** The link of a series, from `s=` on, whatever stands around it; `null`: there is none in the text. */
export const seriesLinkIn = (text: string): string | null =>
  /(?:^|[#\s>"'])(s=\d{1,9}\.[\w-]+)/.exec(text)?.[1] ?? null;

/** Links of projects and series, from `p=` or `s=` on, and ids of ready courses in addresses, in their order. */
export const taskLinksIn = (text: string): readonly ({ readonly link: string } | { readonly course: string })[] =>
  Array.from(
    ` ${text}`.matchAll(/[#\s>"']([ps]=\d{1,9}\.[\w-]+)|(?:#courses?[/=]|[?&]task=)([\w-]+)/g),
    ([, link, course = '']) => (link === undefined ? { course } : { link }),
  );

function addressesIn(
  line: string,
): readonly { readonly address: string; readonly start: number; readonly end: number }[] {
  return Array.from(line.matchAll(ADDRESS), (match) => ({
    address: match[0].slice(0, lengthWithout(match[0], AFTER_ADDRESS)),
    start: match.index,
    end: match.index + match[0].length,
  })).filter(({ address }) => /[#?&]([pr]=\d|(code|fs)=)/.test(address));
}

/** The name in the words before a link, without the signs around it; empty if it is too long for a name. */
function nameIn(text: string): string {
  const ended = text.slice(0, lengthWithout(text, AFTER_NAME));
  let start = 0;
  while (start < ended.length && BEFORE_NAME.test(ended.charAt(start))) start += 1;
  return ended.length - start > NAME_CHARACTERS ? '' : ended.slice(start);
}

/** Characters that end a sentence or a bracket and not an address; characters around names. */
const [AFTER_ADDRESS, BEFORE_NAME, AFTER_NAME] = [/[.,;:)\]}!?]/, /[\s\-*•<>|"'([{,;]/, /[\s\-–:=<>|"'([{,;]/];

/** The length of a text without such signs at its end. A pattern would take hours for a megabyte of spaces. */
function lengthWithout(text: string, sign: RegExp): number {
  let end = text.length;
  while (end > 0 && sign.test(text.charAt(end - 1))) end -= 1;
  return end;
}

/**
 * The links of a saved e-mail. A single one is its sender's, unless it stands behind a name and a colon: what is on the line
 * before is a greeting, and “Here:” is nobody's name.
 */
function linksInMail(source: string): readonly NamedLink[] {
  const { from, text } = readMail(source, { isWanted: (part) => linksIn(part).length > 0, textOfPage });
  const links = linksIn(text);
  const [only, another] = links;
  if (only === undefined || another !== undefined || from === '') return links;
  const before = text.slice(0, text.indexOf(only.address)).split('\n').at(-1)?.trimEnd() ?? '';
  const name = before.endsWith(':') ? nameIn(before) : '';
  return [{ ...only, name: name === '' || isPointing(name) ? from : name }];
}

const wordSet = (text: string): ReadonlySet<string> => new Set(text.split(' '));
/** Words that point to a link by themselves, as in “Here:”. */
const ALONE = wordSet('hier hiermit anbei voici voilà ici qui ecco here this');
/** Names of a link, and the words that may stand before it, as in “Das ist mein Programm:”. */
const THINGS = wordSet(
  'link lien programm program programma programme lösung solution soluzione abgabe travail compito',
);
const BEFORE_THINGS = wordSet(
  'hier hiermit anbei da das dies der die mein meine unser unsere ist guten tag hallo voici voilà ici le la ma mon notre c’est bonjour qui ecco questo questa è il mio nostro buongiorno ciao here here’s this the my our is hello',
);

/** Whether the words before a link in a letter are no name, such as “Hier ist mein Link”. */
function isPointing(name: string): boolean {
  const words = name
    .toLowerCase()
    .replaceAll("'", '’')
    .split(/[\s,]+/);
  const last = words.pop() ?? '';
  return THINGS.has(last) ? words.every((word) => BEFORE_THINGS.has(word)) : words.length === 0 && ALONE.has(last);
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
  const rows: string[][] = [[]];
  let mayClose = true;
  for (let at = 0; at < text.length; at += 1) {
    const isQuoted = mayClose && text[at] === '"';
    const close: number = isQuoted ? closingQuote(text, at) : -1;
    // Looked for once: a file full of quotes would take hours.
    if (isQuoted) mayClose = close >= 0;
    const from = close < 0 ? at : close + 1;
    let end = from;
    while (end < text.length && text[end] !== sign && text[end] !== '\n') end += 1;
    const inQuotes = close < 0 ? '' : text.slice(at + 1, close).replaceAll('""', '"');
    rows.at(-1)?.push(inQuotes + text.slice(from, end));
    if (text[end] === '\n') rows.push([]);
    at = end;
  }
  return rows;
}

/** The place where the quote at this place ends; −1: nowhere, and no later one ends either. */
function closingQuote(text: string, open: number): number {
  let close = text.indexOf('"', open + 1);
  while (close >= 0 && text[close + 1] === '"') close = text.indexOf('"', close + 2);
  return close;
}

/** The text of a page with the addresses of its links. Read tag by tag: a pattern would take hours for some pages. */
function textOfPage(html: string): string {
  const parts: string[] = [];
  let link: { readonly address: string; readonly from: number } | null = null;
  let from = 0;
  for (let open = html.indexOf('<'); open >= 0; open = html.indexOf('<', from)) {
    const close = html.indexOf('>', open);
    if (close < 0) break;
    parts.push(html.slice(from, open));
    from = close + 1;
    const [, end, name = '', rest = ''] = /^<(\/?)([a-z\d]*)(.*)$/is.exec(html.slice(open, close)) ?? [];
    const address = /\bhref\s*=\s*["']?([^"'\s]+)/i.exec(rest)?.[1];
    if (/^a$/i.test(name) && link !== null) {
      // Where the address itself is shown it would be there twice.
      const shown = parts.splice(link.from).join('');
      parts.push(/https?:|#[pr]=/i.test(shown) ? ` ${link.address} ` : ` ${shown} ${link.address} `);
      link = null;
    }
    if (/^a$/i.test(name) && address !== undefined) link = { address, from: parts.length };
    parts.push((end !== '' && /^(p|div|li|tr|h\d)$/i.test(name)) || /^br$/i.test(name) ? '\n' : ' ');
  }
  return [...parts, html.slice(from)]
    .join('')
    .replace(/&(amp|lt|gt|quot|nbsp|#39);/g, (_, name: string) => entities[name] ?? ' ');
}

const entities: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };
