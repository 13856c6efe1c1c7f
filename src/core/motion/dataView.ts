import type { DataColumn, SystemView } from '../model/system.ts';

/** Of data: a motion of no system. Its columns are all that is known of it. */
export const DATA = 'data';

/**
 * What stands in a system's place for numbers that name no system's coordinates: no bodies, no equations, its columns
 * with their units. Charts, tables and exports read it as they read any other.
 *
 * @param title of the file
 * @param columns all but `t`, in the units they are recorded in (SI and radians)
 */
export function dataView(title: string, columns: readonly DataColumn[]): SystemView {
  return {
    meta: {
      id: DATA,
      title,
      order: 1,
      coordinates: [],
      parameters: [],
      parameterSets: {},
      constraintSets: [],
      inputs: [],
      bodies: [],
      columns,
    },
    poses: () => {},
    contacts: [],
  };
}
