/** A mesh file and its materials as objects of three.js. */
import { BufferGeometry, Float32BufferAttribute, Group, Mesh } from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import type { MeshPair } from '../contract.ts';
import { surfaceFrom } from './materials.ts';
import { type MeshPart, readMaterials, readMesh } from './meshText.ts';

/** Edges sharper than this (rad) stay edges where the file gives no normals. */
const CREASE = 0.6;

/** One pair as a group in the body's own frame (m), a mesh a part. Throws `MeshError`; never touches the network. */
export function parsePair(pair: MeshPair, name: string): Group {
  const parts = readMesh(pair.mdl, `${name}.mdl`);
  const materials = readMaterials(pair.mat, `${name}.mat`);
  const withNormals = /^\s*vn\s/m.test(pair.mdl);
  const group = new Group();
  for (const part of parts) {
    const surfaces = part.uses.map(({ material }) => surfaceFrom(material, materials.get(material)));
    const mesh = new Mesh(geometryOf(part, withNormals), surfaces.length > 1 ? surfaces : surfaces[0]);
    mesh.name = part.name;
    mesh.castShadow = mesh.receiveShadow = true;
    group.add(mesh);
  }
  return group;
}

function geometryOf({ positions, normals, uses }: MeshPart, withNormals: boolean): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  if (uses.length > 1)
    uses.forEach(({ start }, i) => {
      geometry.addGroup(start, (uses[i + 1]?.start ?? positions.length / 3) - start, i);
    });
  return withNormals ? geometry : toCreasedNormals(geometry, CREASE);
}
