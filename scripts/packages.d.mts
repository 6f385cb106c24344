/** Each folder of `packages/` and the module that it is made of. `hasApp`: the built app is in it, too. */
export const packages: readonly { readonly folder: string; readonly entry: string; readonly hasApp: boolean }[];

/**
 * Builds and packs `packages/*`.
 *
 * @param out absolute path of the folder for the tarballs, which is emptied first
 * @param choice only: folders of `packages/`; app: the folder of the built app, else `dist/app`
 * @returns name of the package → path of its tarball
 */
export function packAll(
  out?: string,
  choice?: { readonly only?: readonly string[]; readonly app?: string },
): Promise<Readonly<Record<string, string>>>;
