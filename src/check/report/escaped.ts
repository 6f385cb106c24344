import { plainText } from '#core/unseen';

const entities: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };

/** A text for XML and HTML, in which nothing is hidden, without the signs that XML does not allow. */
export const escaped = (text: string): string =>
  plainText(text)
    .replace(/[&<>"]/g, (sign) => entities[sign] ?? sign)
    .replace(/[\ud800-\udfff\ufffe\uffff]/gu, '\ufffd');
