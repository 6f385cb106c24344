/** The parts that the single-file build puts into the page (`vite.config.ts`, mode `single`). */

/** The worker as a classic script. */
declare module 'single:worker' {
  const code: string;
  export default code;
}

/** The VM: gzip, base64. */
declare module 'single:firmware' {
  const packed: string;
  export default packed;
}
