#!/usr/bin/env bash
# Make the pictures of the tutorials, content/images/*.png, and print what their programs print: on a
# generated scene, with the programs of the build directory.
# Usage: doc/tutorials/make_images.sh BUILD_DIR [OUTPUT_DIR]
# Needs xvfb-run without a display, python3-matplotlib and python3-pil.
set -euo pipefail
[[ -n ${DISPLAY:-} ]] || exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$0" "$@"

build=$(cd "${1:?usage: doc/tutorials/make_images.sh BUILD_DIR [OUTPUT_DIR]}" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
images=$(cd "${2:-$here/content/images}" && pwd)
export PATH=$build/apps:$build/doc/tutorials:$PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

run() { # COMMAND ...: as in the tutorials
  echo "\$ $*"
  "$@"
}

view() { # NAME CLOUD VIEWER_OPTION ...
  pcl_shape_viewer "${@:2}" -screenshot "$1.png" >/dev/null
}

picture() { # NAME CLOUD VIEWER_OPTION ...
  view "$@"
  "${PYTHON:-python3}" "$here"/../../scripts/draw/fewer_colors.py "$1.png" "$images/$1.png" 128
}

sheet() { # NAME COLUMNS WIDTH TITLE=PICTURE ...
  "${PYTHON:-python3}" "$here"/../../scripts/draw/contact_sheet.py "$images/$1.png" "$2" "$3" 128 "${@:4}"
}

# The objects of the scene, without the borders of the table.
camera=0,0,0,-0.03,0.02,0.9,0,-1,0,31

run pcl_shape_scene scene.pcd -seed 2

run tutorial_shape_edge_detection scene.pcd
run pcl_shape_edge_detection scene.pcd types.pcd -types -lines lines.json
picture shape_edge_detection_types types.pcd -field edge_type -camera $camera -size 720x540
picture shape_edge_detection_lines types.pcd -field plain -lines lines.json -camera $camera -size 720x540

run tutorial_shape_back_projection scene.pcd
run pcl_shape_back_projection scene.pcd surfaces.pcd
picture shape_back_projection surfaces.pcd -field likelihood,surface -camera $camera -size 1200x450

run tutorial_shape_model
picture shape_model sheets.pcd -field label -names 0=unknown,1=flat,2=corrugated -size 960x400 \
  -camera 0.55,-0.8,-0.3,0.55,0.15,1.02,0,-1,0,19
for sheet in flat corrugated; do
  run pcl_shape_histogram $sheet.pcd model.json -radius 0.025 -bins 60 -name $sheet
  "${PYTHON:-python3}" "$here"/../../scripts/draw/draw_histogram.py model.json \
    "$images/shape_model_$sheet.png" $sheet
done

run tutorial_normal_estimation_sweep scene.pcd
run pcl_shape_edge_detection scene.pcd normals.pcd -normals
picture normal_estimation_sweep normals.pcd -field plain -shade -normals -camera $camera -size 720x540

run pcl_shape_scene front.pcd -seed 2
run pcl_shape_scene right.pcd -seed 2 -turn 30
run tutorial_salient_points front.pcd right.pcd both.pcd
picture salient_points both.pcd -field label -names 1=first,2=second

around=(-camera 0,0,0,-0.03,0.06,0.9,0,-1,0,31 -size 480x360 -shade)
run pcl_shape_scene objects.pcd -seed 7 -objects 9 -shapes cylinder,box,sphere -normals
view objects objects.pcd -field plain "${around[@]}"
for class in curved object; do
  run pcl_shape_instances objects.pcd instances.pcd -class $class
  view $class instances.pcd -field instance "${around[@]}"
done
sheet shape_instances 3 480 "the scene=objects.png" "curved instances=curved.png" "whole objects=object.png"

run pcl_shape_scene boxes.pcd -seed 5 -normals
run pcl_shape_grasp boxes.pcd -field instance -value 2 -json grasps.json
picture suction_grasps boxes.pcd -field plain -shade -grasps grasps.json -camera 0,0,0,0.075,-0.03,0.7,0,-1,0,22 -size 640x540

for beams in 64 16; do
  run pcl_shape_scene street.pcd -sensor lidar -beams $beams -seed 1
  run pcl_shape_ground street.pcd ground.pcd
  view $beams ground.pcd -field ground -camera 7.5,0,100,7.5,0,0,0,1,0,16 -size 960x360 -point_size 1
done
sheet shape_ground_segmentation 1 960 "64 beams=64.png" "16 beams=16.png"
