/** The files of the zip for a school by their names. @param app the folder of the built app, else `dist/app` */
export function schoolFiles(app?: string): Promise<ReadonlyMap<string, Uint8Array>>;
/** Packs them. */
export function schoolZip(files: ReadonlyMap<string, Uint8Array>): Uint8Array;
