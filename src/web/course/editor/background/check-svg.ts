/** Why a drawing is refused. */
export type SvgProblem = 'no-svg' | 'unsafe';

/** Elements that run code, move or embed other documents. A picture must be still and self-contained. */
const FORBIDDEN_ELEMENTS = [
  'script',
  'handler',
  'listener',
  'foreignObject',
  'iframe',
  'embed',
  'object',
  'audio',
  'video',
  'canvas',
  'link',
  'animate',
  'animateColor',
  'animateMotion',
  'animateTransform',
  'set',
  'discard',
].map((name) => name.toLowerCase());

/**
 * Checks the text of an SVG file: it must contain only a still picture. It is shown as an image, where browsers run no
 * scripts and fetch nothing anyway, and only its pixels are kept. The check makes sure that a picture is the same
 * wherever it is opened, and reports if it would not be. It is strict on purpose: dangerous text is refused even in a
 * comment.
 */
export function svgProblem(text: string): SvgProblem | null {
  const root = rootOf(text);
  if (root === null) return 'no-svg';
  // A document type with entities of its own could stand for anything; a style sheet may come from elsewhere.
  if (root === 'unsafe' || /<!ENTITY|<!DOCTYPE|<\?xml-stylesheet/i.test(text.slice(root))) return 'unsafe';
  const plain = withoutCharacterReferences(text);
  for (const match of plain.matchAll(/<\s*(?:[\w.-]+:)?([\w.-]+)/g))
    if (FORBIDDEN_ELEMENTS.includes((match[1] ?? '').toLowerCase())) return 'unsafe';
  if (/[\s"'/]on[a-z]+\s*=\s*["']/i.test(plain)) return 'unsafe';
  if (/@import|expression\s*\(|javascript:|vbscript:/i.test(plain)) return 'unsafe';
  return hasForeignReference(plain) ? 'unsafe' : null;
}

/** Start of the root element, after the prolog; `null` if it is not an SVG. */
function rootOf(text: string): number | 'unsafe' | null {
  let at = /^[\s\uFEFF]*/.exec(text)?.[0].length ?? 0;
  for (;;) {
    const rest = text.slice(at, at + 20);
    if (/^<(\w+:)?svg[\s>/]/i.test(rest)) return at;
    const end = rest.startsWith('<!--') ? '-->' : rest.startsWith('<?') ? '?>' : /^<!DOCTYPE/i.test(rest) ? '>' : null;
    if (end === null) return null;
    const stop = text.indexOf(end, at + 4);
    if (stop < 0) return null;
    const before = text.slice(at, stop);
    if (end === '>' && before.includes('[')) return 'unsafe';
    if (end === '?>' && !/^<\?xml\s/i.test(before)) return 'unsafe';
    at = stop + end.length;
    while (/\s/.test(text.charAt(at))) at += 1;
  }
}

/** References may only point into the drawing itself (`#id`) or to an embedded picture. */
function hasForeignReference(text: string): boolean {
  const own = /^\s*(#|data:image\/(png|jpe?g|gif|webp);base64,|$)/i;
  for (const match of text.matchAll(/[\s"'](?:[\w.-]+:)?(?:href|src)\s*=\s*(?:"([^"]*)"|'([^']*)')/gi))
    if (!own.test(match[1] ?? match[2] ?? '')) return true;
  for (const match of text.matchAll(/url\(\s{0,50}["']?([^)]{0,300})/gi)) if (!own.test(match[1] ?? '')) return true;
  return false;
}

/** Decodes `&#106;`, `&#x6a;` and CSS escapes, so that nothing can hide behind them. */
function withoutCharacterReferences(text: string): string {
  const letter = (code: number): string => (code > 0 && code <= 0x10ffff ? String.fromCodePoint(code) : '');
  return text
    .replace(/&#x([0-9a-f]{1,6});?/gi, (_, hex: string) => letter(Number.parseInt(hex, 16)))
    .replace(/&#(\d{1,7});?/g, (_, digits: string) => letter(Number(digits)))
    .replace(/&quot;|&apos;/g, "'")
    .replace(/\\([0-9a-f]{1,6})\s?/gi, (_, hex: string) => letter(Number.parseInt(hex, 16)));
}

/** Width and height of a drawing in its own units, or `null` if it does not state them. */
export function svgSize(text: string): { readonly width: number; readonly height: number } | null {
  const root = /<(?:\w+:)?svg\b[^>]*>/i.exec(text)?.[0] ?? '';
  const attribute = (name: string): string => {
    const match = new RegExp(`\\s${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`, 'i').exec(root);
    return match?.[1] ?? match?.[2] ?? '';
  };
  const [, , boxWidth = NaN, boxHeight = NaN] = attribute('viewBox')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const box = isExtent(boxWidth) && isExtent(boxHeight) ? { width: boxWidth, height: boxHeight } : null;
  if (box !== null) return box;
  // Percentages say nothing about the proportions.
  const length = (value: string): number => (value.trim().endsWith('%') ? NaN : Number.parseFloat(value));
  const [width, height] = [length(attribute('width')), length(attribute('height'))];
  return isExtent(width) && isExtent(height) ? { width, height } : null;
}

const isExtent = (value: number): boolean => Number.isFinite(value) && value > 0 && value < 1e7;
