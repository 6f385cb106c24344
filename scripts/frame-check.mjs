// What a page says where it cannot start, and the script that finds out why (decisions 0018 and 0073).
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { root } from './progress.mjs';

const FOLDER = 'src/web/app/frame-check';

/**
 * The parts of the check: a classic script, styles and the sentences in four languages.
 *
 * @returns {Promise<{ script: string, css: string, html: string }>}
 */
export async function frameCheckParts() {
  const read = async (ending) =>
    (await readFile(join(root, FOLDER, `frame-check.${ending}`), 'utf8')).replace(/\r\n/g, '\n').trim();
  const html = await read('html');
  const css = await read('css');
  return {
    script: lighter(await read('js')),
    css: css.replace(/\s*\n\s*/g, ''),
    html: html.replace(/\s+/g, ' ').replace(/> </g, '><'),
  };
}

/** A script without its comments and its indentation; both stand on lines of their own. */
const lighter = (script) => script.replace(/^\s*\/\/.*\n/gm, '').replace(/^\s+/gm, '');

/** A script's source for a content policy. @param {string} script */
export const scriptHash = (script) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`;

/** The page's own policy, as it stands in the page's source. */
const POLICY = /<meta\s+http-equiv="Content-Security-Policy"\s+content="([^"]*)"\s*\/>/;

/**
 * The page with the check inside. Its script comes first and sets the page's policy; the sentences stand where the app takes
 * their place.
 *
 * @param {string} page
 * @param {{ script: string, css: string, html: string }} parts
 * @throws Error where the page does not look as expected
 */
export function withFrameCheck(page, { script, css, html }) {
  let result = page;
  const put = (pattern, replacement) => {
    if (!pattern.test(result)) throw new Error(`The page has nothing like ${pattern}.`);
    result = result.replace(pattern, replacement);
  };
  put(POLICY, (_, policy) => `<meta name="policy" content="${policy}" />\n    <script>${script}</script>`);
  put(/<\/title>/, (title) => `${title}\n    <style>${css}</style>`);
  put(/<div id="app">/, (app) => app + html);
  return result;
}

/** Inside a single file, which needs no origin and has its files inside: the other reasons not to start remain. */
export function withSingleCheck(page, parts) {
  const html = parts.html.replace(/<div class="(frame|folder)">.*?<\/div>/g, '');
  return withFrameCheck(page, { ...parts, html }).replace('<html ', '<html data-single ');
}
