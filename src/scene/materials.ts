import * as THREE from 'three';

/** Roughness and metalness by material name of the meshes; a dropped mesh with other names gets the last line. */
const FINISH: Readonly<Record<string, [roughness: number, metalness: number]>> = {
  'deck-rubber': [0.82, 0],
  grip: [0.95, 0],
  accent: [0.45, 0],
  shell: [0.6, 0.05],
  aluminium: [0.38, 0.75],
  steel: [0.3, 0.85],
  urethane: [0.32, 0],
  mark: [0.5, 0],
  seal: [0.7, 0],
  other: [0.7, 0.05],
};

export function finishOf(name: string): [roughness: number, metalness: number] {
  return FINISH[name] ?? FINISH['other']!;
}

/** A physically based material with the colour of the file's and the finish of its name. */
export function materialFor(source: THREE.Material, accent: string): THREE.MeshStandardMaterial {
  const [roughness, metalness] = finishOf(source.name);
  const given = (source as THREE.MeshPhongMaterial).color ?? new THREE.Color(0.6, 0.6, 0.6);
  const color = source.name === 'accent' ? new THREE.Color(accent) : given.clone();
  const material = new THREE.MeshStandardMaterial({ name: source.name, color, roughness, metalness });
  material.side = source.side;
  return material;
}
