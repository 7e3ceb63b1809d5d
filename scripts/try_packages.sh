#!/usr/bin/env bash
# Use the installed packages as their users do; for scripts/build_packages.sh.
# Usage: scripts/try_packages.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "A scene, its surfaces and edges, and the truth:"
pcl_shape_scene "$work/scene.pcd"
pcl_shape_detect "$work/scene.pcd" "$work/detected.pcd"
pcl_shape_evaluate "$work/detected.pcd" "$work/scene.pcd" -task planar
pcl_shape_evaluate "$work/detected.pcd" "$work/scene.pcd" -task edge

echo "A picture:"
xvfb-run -a pcl_shape_viewer "$work/detected.pcd" -field surface -screenshot "$work/picture.png"
test -s "$work/picture.png"

echo "Pages and completions:"
for app in /usr/bin/pcl_shape_* /usr/bin/pcl_inad_*; do
  name=$(basename "$app")
  test -e "/usr/share/man/man1/$name.1.gz" || test ! -d /usr/share/man/man1
  bash -c "source /usr/share/bash-completion/completions/$name && complete -p $name"
done

echo "Python:"
cd "$work"
python3 - <<'PYTHON'
import numpy as np
import pcl_shape
points = np.random.default_rng(1).uniform(0, 1, (5000, 3))
points[:, 2] = 0
field = pcl_shape.detect(points)
print(pcl_shape.__version__, field, f"{(field.surface == 1).mean():.3f} planar")
assert (field.surface == 1).mean() > 0.9
PYTHON
cd - >/dev/null

echo "A CMake project outside:"
cmake -S test/package/consumer -B "$work/consumer" -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build "$work/consumer"
"$work/consumer/consumer" "$work/model.json"
echo "The packages work."
