/** A link in a text, and who it is from. */
export interface NamedLink {
  /** Empty: nobody says. */
  readonly name: string;
  readonly address: string;
}

/** An address of a project or a program, or only the part of it from `#` on. */
const ADDRESS = /(?:https?:\/\/[^\s<>"']+|#p=\d{1,9}\.[\w-]+=*)/gi;

/** Chosen: a name stands on the line of its link or before it, and is short. */
const NAME_CHARACTERS = 60;

/**
 * The links in a text, whatever stands around them, such as a whole e-mail. The name of a link is what stands before it on
 * its line, else on the line before; empty where nothing does. Addresses that lead somewhere else are left out.
 */
export function linksIn(text: string): readonly NamedLink[] {
  const links: NamedLink[] = [];
  let before = '';
  for (const line of text.split(/\r?\n/)) {
    let from = 0;
    for (const match of line.matchAll(ADDRESS)) {
      const address = match[0].replace(/[.,;:)\]}!?]+$/, '');
      if (!/[#?&](p=\d|code=)/.test(address)) continue;
      const name = nameIn(line.slice(from, match.index)) || nameIn(before);
      links.push({ name, address });
      [from, before] = [match.index + match[0].length, ''];
    }
    if (from > 0) before = '';
    else if (line.trim() !== '') before = line;
  }
  return links;
}

/** The words without what parts them from the link. */
function nameIn(text: string): string {
  const words = text.replace(/^[\s\-*•<>|"'([{,;]+|[\s\-–:=<>|"'([{,;]+$/g, '').trim();
  return words.length > NAME_CHARACTERS ? '' : words;
}
