/**
 * Tells whether a file's name changes with what is in it: six to eight characters of its hash.
 *
 * @param {string} path below the app, such as `assets/page-Dx3k9_aQ.js`
 */
export const isNamedByContent = (path) => /^assets\/.*-[\w-]{6,8}\.\w+$/.test(path);
