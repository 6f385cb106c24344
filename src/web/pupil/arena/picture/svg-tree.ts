/** An element of an SVG text, with the places where its text starts and ends. */
export interface SvgElement {
  readonly name: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly children: readonly SvgElement[];
  readonly start: number;
  readonly end: number;
}

interface OpenElement {
  readonly name: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly children: SvgElement[];
  readonly start: number;
}

const TAG = /<!--[\s\S]*?-->|<(\/?)([\w:-]+)((?:"[^"]*"|'[^']*'|[^>"'])*?)(\/?)>/g;

/**
 * Reads the elements of a well-formed SVG text into a tree; text and comments are left out. It needs no browser, so
 * drawings can be tested anywhere. Tags that do not match close what is open; nothing throws.
 *
 * @returns a root named `#document` that holds what stands at the top
 */
export function readSvgTree(svg: string): SvgElement {
  const open: OpenElement[] = [{ name: '#document', attributes: {}, children: [], start: 0 }];
  const close = (end: number): SvgElement | null => {
    const element = open.length > 1 ? open.pop() : undefined;
    if (element === undefined) return null;
    const closed = { ...element, end };
    open[open.length - 1]?.children.push(closed);
    return closed;
  };
  for (const tag of svg.matchAll(TAG)) {
    const name = tag[2];
    if (name === undefined) continue;
    const end = tag.index + tag[0].length;
    if (tag[1] === '/') {
      close(end);
      continue;
    }
    open.push({ name, attributes: attributesOf(tag[3] ?? ''), children: [], start: tag.index });
    if (tag[4] === '/') close(end);
  }
  while (close(svg.length) !== null);
  return { name: '#document', attributes: {}, children: open[0]?.children ?? [], start: 0, end: svg.length };
}

/** The element and all below it, in the order of the text. */
export function* elementsOf(element: SvgElement): Generator<SvgElement> {
  yield element;
  for (const child of element.children) yield* elementsOf(child);
}

function attributesOf(text: string): Readonly<Record<string, string>> {
  const attributes: Record<string, string> = {};
  for (const match of text.matchAll(/([\w:-]+)\s*=\s*(?:"([^"]*)"|'([^']*)')/g))
    attributes[match[1] ?? ''] = match[2] ?? match[3] ?? '';
  return attributes;
}
